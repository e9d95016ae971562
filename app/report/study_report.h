#pragma once

#include <QIODevice>

#include "core/study/study.h"

namespace noonmark {

/// The report of a study as a PDF of one A4 page: maps, numbers, method, error, inputs with their hashes,
/// warnings, and how to repeat it. Text stays text. Writes to `device`, which is open; whether everything
/// arrived is for the caller to ask it. False when no PDF could be begun.
bool writeReport(const Study& study, QIODevice& device);

}  // namespace noonmark
