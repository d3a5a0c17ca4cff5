#include "foundation/processes/guarded_call.h"

#include <gmock/gmock.h>

#include <memory>
#include <stdexcept>

namespace rig {
struct Trouble {};
}  // namespace rig

namespace lacuna {
namespace {

using testing::StrEq;
using testing::ThrowsMessage;

const ComponentOrigin kOrigin{"effect", "drag", "/opt/drag.so"};

TEST(GuardedCall, ReturnsWhatTheCallReturnsAsItIs) {
  int value = 3;
  int& same = guarded_call(kOrigin, "describe", [&]() -> int& { return value; });
  EXPECT_EQ(&same, &value);
  const auto owned = guarded_call(kOrigin, "create", [] { return std::make_unique<int>(4); });
  EXPECT_EQ(*owned, 4);
}

TEST(GuardedCall, AnErrorKeepsItsSentenceBehindTheComponent) {
  EXPECT_THAT([] { guarded_call(kOrigin, "amend", [] { throw Error("place it on hinges"); }); },
              ThrowsMessage<Error>(StrEq("effect \"drag\" (/opt/drag.so): place it on hinges")));
}

TEST(GuardedCall, AStandardExceptionIsNamedWithItsType) {
  EXPECT_THAT(
      [] { guarded_call(kOrigin, "amend", [] { throw std::out_of_range("index 7"); }); },
      ThrowsMessage<Error>(StrEq("effect \"drag\" (/opt/drag.so): amend threw std::out_of_range (index 7); this "
                                 "is a fault of the plugin: repair it or leave this component out")));
}

TEST(GuardedCall, AForeignTypeIsNamed) {
  EXPECT_THAT([] { guarded_call(kOrigin, "amend", [] { throw rig::Trouble{}; }); },
              ThrowsMessage<Error>(testing::HasSubstr("amend threw an object of type rig::Trouble; this is a fault")));
  EXPECT_THAT([] { guarded_call(kOrigin, "amend", [] { throw 7; }); },
              ThrowsMessage<Error>(testing::HasSubstr("an object of type int")));
}

TEST(GuardedCall, WhatTheHostsServicesThrowPassesUnchanged) {
  const auto bad_input = [] {
    ProblemList problems;
    problems.add({"data.csv", 3, 1}, "not a number");
    problems.throw_if_any();
  };
  EXPECT_THROW(guarded_call(kOrigin, "recorded", bad_input), BadInput);
  EXPECT_THROW(guarded_call(kOrigin, "recorded", [] { throw Interrupted("stop"); }), Interrupted);
}

TEST(GuardedCall, KeepsTheReasonWithoutTheComponent) {
  const auto reason = [](const auto& call) {
    try {
      guarded_call(kOrigin, "amend", call);
    } catch (const Error& error) {
      return reason_of(error);
    }
    return std::string();
  };
  EXPECT_EQ(reason([] { throw Error("place it on hinges (not in a.so): nowhere else"); }),
            "place it on hinges (not in a.so): nowhere else");
  EXPECT_THAT(reason([] { throw 7; }), testing::StartsWith("amend threw an object of type int; "));
}

TEST(ReasonOf, IsThatOfTheFirstProblemWithoutPlaceAndKey) {
  ProblemList problems;
  problems.add_of_key({"rig.toml", 3, 1}, "model.effects[0]", to_string(kOrigin) + ": too heavy", "too heavy");
  problems.add_of_key({"rig.toml", 4, 1}, "engine.step", "is not above 0");
  EXPECT_EQ(reason_of(BadInput(problems.all())), "too heavy");
  EXPECT_EQ(reason_of(BadInput({problems.all()[1]})), "is not above 0");
  EXPECT_EQ(reason_of(BadInput({Problem{{"rig.toml"}, "is empty"}})), "is empty");
  EXPECT_EQ(reason_of(Error("no disk")), "no disk");
}

TEST(ComponentOrigin, OfTheProgramItselfHasNoFile) {
  EXPECT_EQ(to_string(ComponentOrigin{"metric", "mean", {}}), "metric \"mean\"");
}

}  // namespace
}  // namespace lacuna
