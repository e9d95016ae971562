#pragma once

class QApplication;

namespace noonmark {

/// Qt3D draws through its OpenGL renderer, which is the fast one on software OpenGL. Before the application
/// is made.
void chooseRenderer();

/// Names, style and colours that are the same on every desktop: calm and light.
void applyAppearance(QApplication& application);

}  // namespace noonmark
