#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "app/gui/base/looks/theme.h"

namespace noonmark {

/// States which theme the desktop prefers.
class ThemeSource : public QObject {
    Q_OBJECT
public:
    /// Nothing where the desktop states no preference, or none is known yet.
    [[nodiscard]] virtual std::optional<Theme> theme() const = 0;

Q_SIGNALS:
    void changed();  ///< theme() may have changed
};

/// The setting "color-scheme" of the desktop portal (org.freedesktop.portal.Settings) on the session bus:
/// read now, without waiting for the answer, and whenever it changes. Null where there is no session bus, or
/// where Noonmark was built without D-Bus.
std::unique_ptr<ThemeSource> makePortalThemeSource();
/// The same on the bus at this address, for tests.
std::unique_ptr<ThemeSource> makePortalThemeSource(const QString& busAddress);

}  // namespace noonmark
