#pragma once

#include <QIcon>

namespace noonmark {

/// The icon of that name in resources/icons, in the colours of the application's palette, at any size and in
/// either theme; greyed where disabled. An unknown name gives an icon without a picture.
QIcon makeIcon(const QString& name);

}  // namespace noonmark
