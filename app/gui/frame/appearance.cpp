#include "app/gui/frame/appearance.h"

#include <QApplication>
#include <QIcon>
#include <QPalette>
#include <QSettings>

#include "app/gui/base/looks/application_theme.h"
#include "app/gui/base/looks/language.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/base/looks/window_style.h"
#include "app/gui/base/widgets/wheel_guard.h"
#include "core/base/version.h"

namespace noonmark {

void chooseRenderer() {
    if (!qEnvironmentVariableIsSet("QT3D_RENDERER")) qputenv("QT3D_RENDERER", "opengl");
    // The start page is a window of its own. Its siblings would become such windows, too, and cover the view.
    QCoreApplication::setAttribute(Qt::AA_DontCreateNativeWidgetSiblings);
}

void applyAppearance(QApplication& application) {
    QApplication::setOrganizationName(QStringLiteral("Noonmark"));
    QApplication::setApplicationName(QStringLiteral("Noonmark"));
    QApplication::setApplicationVersion(QString::fromUtf8(version().data(), qsizetype(version().size())));
    // The desktop finds the window's name and icon by it (resources/desktop).
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.noonmark.Noonmark"));
    QApplication::setWindowIcon(QIcon::fromTheme(QStringLiteral("io.github.noonmark.Noonmark")));
    const QPalette system = QApplication::palette();  // before the style brings its own
    QApplication::setStyle(new WindowStyle);
    applyLanguage(readLanguage(QSettings()), application);
    applyUnits(readUnits(QSettings()));
    new WheelGuard(application);
    new ApplicationTheme(application, readThemeChoice(QSettings()), system, makePortalThemeSource());
}

}  // namespace noonmark
