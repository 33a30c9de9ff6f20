#include "engine/alarms/alarm_rule.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace vignole {
namespace {

const AlarmRule& rule(const std::vector<AlarmRule>& rules, const std::string& id) {
  const auto found = std::find_if(rules.begin(), rules.end(), [&](const AlarmRule& r) { return r.id == id; });
  EXPECT_NE(found, rules.end()) << id;
  return *found;
}

TEST(AlarmRules, HaveCauseConsequenceAndAction) {
  const auto& rules = standardAlarmRules();
  EXPECT_TRUE(checkAlarmRules(rules));
  EXPECT_EQ(rule(rules, "camera.lost").priority, AlarmPriority::Invalid);
  EXPECT_EQ(rule(rules, "rail.out-of-tolerance").priority, AlarmPriority::OutOfTolerance);
  EXPECT_EQ(rule(rules, "calibration.drift").priority, AlarmPriority::Degraded);
  std::vector<AlarmRule> bad = rules;
  bad[0].action.clear();
  EXPECT_NE(checkAlarmRules(bad).error().message().find("event"), std::string::npos);
  bad = rules;
  bad.push_back(rules[0]);
  EXPECT_NE(checkAlarmRules(bad).error().message().find("twice"), std::string::npos);
  bad = rules;
  bad[0].onDelayS = -1;
  EXPECT_FALSE(checkAlarmRules(bad));
}

TEST(AlarmRules, WhatAFileSaysChangesThatAlone) {
  const auto rules = parseAlarmRules("format = 1\n[alarm.calibration.drift]\nlimit = 0.08\non_delay_s = 5\n", "a.toml");
  ASSERT_TRUE(rules) << rules.error().message();
  EXPECT_EQ(rule(*rules, "calibration.drift").limit, 0.08);
  EXPECT_EQ(rule(*rules, "calibration.drift").onDelayS, 5);
  EXPECT_EQ(rule(*rules, "calibration.drift").filterS, rule(standardAlarmRules(), "calibration.drift").filterS);
  EXPECT_EQ(rule(*rules, "disk.low").limit, rule(standardAlarmRules(), "disk.low").limit);
}

TEST(AlarmRules, AreReadBackAsWritten) {
  std::vector<AlarmRule> rules = standardAlarmRules();
  for (AlarmRule& r : rules) {
    r.onDelayS += 0.125;
    if (r.condition != AlarmCondition::State) r.limit *= 1.1;
  }
  const auto back = parseAlarmRules(toToml(rules), "a.toml");
  ASSERT_TRUE(back) << back.error().message();
  for (std::size_t i = 0; i < rules.size(); ++i) {
    EXPECT_EQ((*back)[i].onDelayS, rules[i].onDelayS);
    EXPECT_NEAR((*back)[i].limit, rules[i].limit, 1e-9);
    EXPECT_EQ((*back)[i].priority, rules[i].priority);
  }
}

TEST(AlarmRules, WhatIsWrongInAFileIsNamed) {
  for (const auto& [text, said] : {std::pair{"[alarm.camera.gone]\npriority = 1\n", "alarm.camera.gone"},
                                   std::pair{"[alarm.camera.lost]\nlimit = 3\n", "alarm.camera.lost.limit"},
                                   std::pair{"[alarm.camera.lost]\non_delay_s = 1e9\n", "0 to 3600"},
                                   std::pair{"[alarm.camera.lost]\npriority = 4\n", "1 to 3"}}) {
    const auto rules = parseAlarmRules(std::string("format = 1\n") + text, "a.toml");
    ASSERT_FALSE(rules) << text;
    EXPECT_NE(rules.error().message().find(said), std::string::npos) << rules.error().message();
    EXPECT_NE(rules.error().message().find("a.toml:"), std::string::npos);
  }
}

}  // namespace
}  // namespace vignole
