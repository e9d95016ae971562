#pragma once

class QToolBar;

namespace noonmark {

struct WindowActions;

/// Arranges the entries that are used most as icons.
void fillToolBar(QToolBar& bar, const WindowActions& actions);

}  // namespace noonmark
