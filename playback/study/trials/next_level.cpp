// SPDX-License-Identifier: GPL-3.0-or-later

#include "playback/study/trials/participant_record.h"

namespace detent::playback {

namespace {

std::size_t firstLevelOf(const Study& study, std::size_t reference) {
  std::size_t at = 0;
  while (study.levels[at].reference != reference) ++at;
  return at;
}

}  // namespace

QuestPlus beliefAfter(const Study& study, const ParticipantRecord& record, std::size_t reference,
                      FeedbackMode mode, std::size_t answers) {
  QuestPlus quest(increasesOf(study, reference));
  const std::size_t first = firstLevelOf(study, reference);
  for (std::size_t i = 0; i < answers; ++i) {
    const Trial& trial = record.plan[i];
    if (trial.practice || trial.mode != mode) continue;
    const StudyLevel& level = *levelOf(study, trial.choices[trial.target]);
    if (level.reference != reference) continue;
    quest.take({static_cast<std::size_t>(&level - &study.levels[first]),
                record.answers[i].answer.choice == trial.target});
  }
  return quest;
}

void placeNextLevel(const Study& study, ParticipantRecord& record) {
  const std::size_t next = record.answers.size();
  if (study.design.kind != StudyKind::threshold || next >= record.plan.size()) return;
  Trial& trial = record.plan[next];
  const std::size_t reference = trial.choices[1 - trial.target];
  std::size_t level = increasesOf(study, reference).size() - 1;  // practice trials have the easiest level
  if (!trial.practice) level = beliefAfter(study, record, reference, trial.mode, next).nextLevel();
  trial.choices[trial.target] = study.levels[firstLevelOf(study, reference) + level].button;
}

}  // namespace detent::playback
