#pragma once

#include "core/describe/field.h"
#include "core/study/study.h"

namespace noonmark {

/// All settings of a study. The region stands with its name only; its polygons are written by those
/// that need them.
const Fields<StudySettings>& studyFields();

/// Parts of that table, for interfaces that take some of them.
const Fields<StudySettings>& airFields();           ///< pressure and temperature
const Fields<StudySettings>& cellFields();          ///< size of a cell
const Fields<StudySettings>& surfaceFields();       ///< ground, roofs or both
const Fields<StudySettings>& engineFields();        ///< engine and its options
const Fields<StudySettings>& monthFields();         ///< months by themselves
const Fields<StudySettings>& contributionFields();  ///< contributions of buildings
const Fields<StudySettings>& treeFields();          ///< which shade of trees is measured
const Fields<ErrorSampleSettings>& sampleFields();  ///< how the error is measured

/// What is written down about the size of a cell, of studies and of reviews.
FieldFacts cellSizeFacts();

}  // namespace noonmark
