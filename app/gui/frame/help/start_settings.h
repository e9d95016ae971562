#pragma once

class QSettings;

namespace noonmark {

/// Whether the start page is shown when the program starts without a file: at first it is.
bool readShowStart(const QSettings& settings);
void saveShowStart(bool shows, QSettings& settings);

}  // namespace noonmark
