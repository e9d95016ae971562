#pragma once

class QWidget;

namespace noonmark {

/// Gives each widget inside that takes the keyboard a name for screen readers, where it has none by its text
/// or label: the first line of its tool tip, or the title of the box or dock that it fills.
void nameForScreenReaders(QWidget& window);

}  // namespace noonmark
