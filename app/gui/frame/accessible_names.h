#pragma once

class QWidget;

namespace noonmark {

/// Gives each widget inside that takes the keyboard a name for screen readers, where it has none by its text
/// or label: the first line of its tool tip, or the name or title of what it is in.
void nameForScreenReaders(QWidget& window);

}  // namespace noonmark
