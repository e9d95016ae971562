#include "app/gui/base/looks/theme_source.h"

// Where Noonmark is built without D-Bus, instead of theme_source_dbus.cpp.
namespace noonmark {

std::unique_ptr<ThemeSource> makePortalThemeSource() { return nullptr; }
std::unique_ptr<ThemeSource> makePortalThemeSource(const QString&) { return nullptr; }

}  // namespace noonmark
