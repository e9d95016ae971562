#pragma once

#include <QString>

class QMainWindow;

namespace noonmark::golden {

/// All that a window says, as text: its title, menus, bars and docks with each widget's kind, name, value and
/// tooltip, and the cells of each table and tree. Read from Qt's own classes alone, so that it is the same
/// whatever the window's classes are called and wherever they lie. The message bar is left out, since its
/// notes leave by themselves.
QString describeWindow(const QMainWindow& window);

}  // namespace noonmark::golden
