#pragma once

#include "app/report/book/paper.h"

class QSettings;

namespace noonmark {

/// The paper of sheets that was last chosen, in a dialog of sheets or in the preferences; at first that of
/// the country, upright.
PageSetup readPageSetup(const QSettings& settings);
void savePageSetup(const PageSetup& setup, QSettings& settings);

}  // namespace noonmark
