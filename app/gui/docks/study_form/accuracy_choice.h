#pragma once

#include <QString>
#include <array>

#include "core/study/study.h"

namespace noonmark {

/// How exactly a study is computed, without the names of engines.
enum class AccuracyChoice {
    quick,      ///< the automatic engine: exact where that is as quick
    exact,      ///< projected shadows, or rays on terrain and roofs
    reference,  ///< the ray reference
    own,        ///< an engine or options of the user's
};

/// In the order of the list; `own` is the last.
inline constexpr std::array allAccuracyChoices{AccuracyChoice::quick, AccuracyChoice::exact,
                                               AccuracyChoice::reference, AccuracyChoice::own};

QString nameOf(AccuracyChoice choice);    ///< "Quick"
QString describe(AccuracyChoice choice);  ///< one line

/// The settings with the engine of the choice and its default options; `own` changes nothing. `terrain`: the
/// city has terrain.
StudySettings applied(AccuracyChoice choice, StudySettings settings, bool terrain);

/// The choice that these settings are. Rays on terrain are the reference.
AccuracyChoice choiceOf(const StudySettings& settings, bool terrain);

/// The settings for analysis as in the paper: inverse accrual maps through the direction graph.
StudySettings asInPaper(StudySettings settings);

}  // namespace noonmark
