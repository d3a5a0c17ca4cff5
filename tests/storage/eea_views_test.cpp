#include "storage/made_up_run.h"
#include "storage/queries/query_output.h"

#include <gtest/gtest.h>

#include <sstream>

namespace lacuna {
namespace {

using test::MadeUpDatabase;
using test::MadeUpRun;

/// Two finished passes and the tests of a third; what the figures are is written in made_up_run.h.
class EeaViews : public testing::Test {
 protected:
  EeaViews() { filled_.advance(MadeUpRun{.passes = 3}, 9); }
  std::string ask(const std::string& sql) {
    std::ostringstream text;
    run_queries(filled_.database, sql, *make_query_output(QueryFormat::csv, text));
    return text.str();
  }

  TestFolder folder_;
  MadeUpDatabase filled_{folder_ / "run.db"};
};

TEST_F(EeaViews, RunsTellHowFarTheyAre) {
  EXPECT_EQ(ask("SELECT run, experiment, replicate, ending, passes_done, passes, best_score, metric, fitness, models,"
                " tests, trials, evaluations, steps, seed FROM eea_runs"),
            "run,experiment,replicate,ending,passes_done,passes,best_score,metric,fitness,models,tests,trials,"
            "evaluations,steps,seed\n"
            "1,quadruped,1,not ended,2,3,0.25,mean_absolute_error,forward_distance,120,30,3,120,120000,3\n");
  const std::vector<EeaRunListing> runs = eea_runs(filled_.database);
  ASSERT_EQ(runs.size(), 1U);
  EXPECT_EQ(runs[0].models, 120U);
  EXPECT_EQ(runs[0].best_score, 0.25);
}

TEST_F(EeaViews, ErrorFallsByPassWhileEvaluationsAddUp) {
  EXPECT_EQ(ask("SELECT pass, trials, error, best_model, evaluations_so_far, steps_so_far FROM error_by_pass"
                " ORDER BY pass"),
            "pass,trials,error,best_model,evaluations_so_far,steps_so_far\n1,1,0.5,40,60,60000\n"
            "2,2,0.25,100,120,120000\n");
}

TEST_F(EeaViews, TheBestModelStandsBesideTheTruth) {
  EXPECT_EQ(ask("SELECT model, generation, address, value, unit, truth, error FROM best_model WHERE pass = 2"),
            "model,generation,address,value,unit,truth,error\n100,2,body.torso.mass,3,kg,2.5,0.5\n"
            "100,2,sensor.knee.delay,0.05,s,,\n");
}

TEST_F(EeaViews, ParameterErrorsAreOfAddressesAndOfGroups) {
  EXPECT_EQ(ask("SELECT pass, address, error, unit FROM parameter_error_by_pass ORDER BY address, pass"),
            "pass,address,error,unit\n1,body.*.mass,1,kg\n2,body.*.mass,0.5,kg\n1,body.torso.mass,1,kg\n"
            "2,body.torso.mass,0.5,kg\n1,sensor.*.delay,0.01,s\n2,sensor.*.delay,0.01,s\n");
}

TEST_F(EeaViews, WhatTheObjectiveMetricSaysOfAnAddressCounts) {
  filled_.database.execute("UPDATE objective_score SET name = 'body.torso.mass', value = 7.5 WHERE position = 0");
  EXPECT_EQ(ask("SELECT pass, error FROM parameter_error_by_pass WHERE address = 'body.torso.mass' ORDER BY pass"),
            "pass,error\n1,7.5\n2,7.5\n");
}

TEST_F(EeaViews, AValueThatTheBestModelDoesNotHaveHasNoError) {
  filled_.database.execute("UPDATE best_value SET value = NULL WHERE position = 0");
  EXPECT_EQ(ask("SELECT address, value, error FROM best_model WHERE pass = 2 AND position = 0"),
            "address,value,error\nbody.torso.mass,,\n");
  EXPECT_EQ(ask("SELECT count(*) AS n FROM parameter_error_by_pass WHERE address = 'body.torso.mass'"), "n\n0\n");
}

TEST_F(EeaViews, TheTransferGapIsOfTestsThatModelsPredicted) {
  EXPECT_EQ(ask("SELECT pass, trial, test, fitness, predicted, measured, gap FROM transfer_gap ORDER BY trial LIMIT 1"),
            "pass,trial,test,fitness,predicted,measured,gap\n2,1,11,forward_distance,2.5,2,-0.5\n");
  EXPECT_EQ(ask("SELECT count(*) AS n FROM transfer_gap"), "n\n2\n") << "the first test was random";
}

TEST_F(EeaViews, EvaluationsAreCountedByPass) {
  EXPECT_EQ(ask("SELECT pass, evaluations, abandoned, reused, invalid, steps, test_evaluations, invalid_tests,"
                " test_steps FROM evaluations WHERE pass = 1"),
            "pass,evaluations,abandoned,reused,invalid,steps,test_evaluations,invalid_tests,test_steps\n"
            "1,60,9,12,6,60000,10,1,10000\n");
}

TEST_F(EeaViews, InvalidEvaluationsHaveTheirReasons) {
  EXPECT_EQ(ask("SELECT kind, reason, count(*) AS n FROM invalid_evaluations GROUP BY kind, reason"),
            "kind,reason,n\nmodel,the state is not finite at 0.31 s,12\ntest,explosion,3\n");
  EXPECT_EQ(
      ask("SELECT pass, generation, number FROM invalid_evaluations WHERE kind = 'model' ORDER BY number LIMIT 2"),
      "pass,generation,number\n1,0,8\n1,0,17\n");
}

TEST_F(EeaViews, TracesNameTheModelThatPredicted) {
  EXPECT_EQ(ask("SELECT trial, kind, run, model, channels FROM traces WHERE model IS NOT NULL ORDER BY id LIMIT 2"),
            "trial,kind,run,model,channels\n\"run 1, trial 0\",predicted,1,40,angle\n"
            "\"run 1, trial 0\",centre_of_mass,1,40,\"x, y, z\"\n");
}

}  // namespace
}  // namespace lacuna
