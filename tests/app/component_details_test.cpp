#include "app/workspace/component_details.h"

#include "plugins/built_catalog.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace lacuna {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

TEST(ComponentDetails, OfAnEffectTellItsPhysics) {
  const std::string text = text_of(details_of(built_catalog(), "viscous_friction").front());
  for (const char* part : {"tau = -damping*v", "place on    joint", "fast motion", "linear_drag", "Automatica",
                           "N*m*s/rad (N*s/m on a slider)", "0, from 0 to 10000"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST(ComponentDetails, TellTheirFileOnlyWhenAsked) {
  const ComponentDetails details = details_of(built_catalog(), "viscous_friction").front();
  EXPECT_THAT(text_of(details), Not(HasSubstr("viscous_friction.so")));
  EXPECT_THAT(text_of(details, true), AllOf(HasSubstr("viscous_friction.so"), HasSubstr(details.listing.sha256)));
}

TEST(ComponentDetails, AsJsonHaveTheSame) {
  const auto json = json_of(details_of(built_catalog(), "coulomb_friction").front());
  EXPECT_EQ(json["kind"], "effect");
  EXPECT_EQ(json["placements"][0], "joint");
  EXPECT_EQ(json["parameters"][0]["name"], "torque");
  EXPECT_EQ(json["parameters"][0]["upper"], 1e4);
  EXPECT_EQ(json["sha256"].get<std::string>().size(), 64U);
}

TEST(ComponentDetails, OfOtherKindsTellTheirParameters) {
  EXPECT_THAT(text_of(details_of(built_catalog(), "quadruped").front()), HasSubstr("torso_mass"));
  EXPECT_THAT(text_of(details_of(built_catalog(), "recorded").front()), HasSubstr("no parameters"));
  EXPECT_THAT(text_of(details_of(built_catalog(), "mean_absolute_difference").front()), HasSubstr("metric"));
}

TEST(ComponentDetails, OfAnUnknownNameBringTheNearest) {
  EXPECT_THAT([] { details_of(built_catalog(), "quadrupeed"); },
              ThrowsMessage<Error>(HasSubstr("did you mean \"quadruped\"?")));
}

}  // namespace
}  // namespace lacuna
