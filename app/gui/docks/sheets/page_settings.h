#pragma once

#include "app/report/book/book.h"

class QSettings;

namespace noonmark {

class ProjectSession;

/// The paper of sheets that was last chosen, in a dialog of sheets or in the preferences; at first that of
/// the country, upright.
PageSetup readPageSetup(const QSettings& settings);
void savePageSetup(const PageSetup& setup, QSettings& settings);

/// Makes title block and units those of the project, which is an undo step where they differ.
void saveTitleBlock(const BookSettings& chosen, ProjectSession& session);

}  // namespace noonmark
