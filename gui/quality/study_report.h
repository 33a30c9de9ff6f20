#pragma once
// The report of a study of runs, as a document: verdict, conditions, Table VI or Table V, the chosen dimension as
// Fig. 9.

#include <QString>

#include "gui/quality/runs_study.h"
#include "report/document.h"

namespace vignole {

enum class RunsStudyKind { Repeatability, Accuracy };

/// Symbol, word and sentence that the study comes to, the same on the screen and on paper.
struct StudyVerdict {
  Standing standing = Standing::None;
  QString word, reason;
};
[[nodiscard]] StudyVerdict verdictOf(const RunsStudy& study, RunsStudyKind kind);

/// Label and value, formulas and constants last. Lengths in mm with one more decimal than a value has.
[[nodiscard]] std::vector<std::pair<QString, QString>> figuresOf(const RepeatabilityResult& result,
                                                                 Dimension dimension);
[[nodiscard]] std::vector<std::pair<QString, QString>> figuresOf(const AccuracyResult& result, Dimension dimension);

/// `recipe`: whose limits were used. `conditions`: where the runs are from.
[[nodiscard]] Document studyReport(const RunsStudy& study, RunsStudyKind kind, Dimension chosen, const Recipe& recipe,
                                   const QString& conditions, bool simulation);

}  // namespace vignole
