#include "app/gui/frame/window_start.h"

#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QIcon>
#include <QPalette>
#include <QSettings>
#include <QSlider>

#include "app/gui/base/looks/application_theme.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/frame/main_window.h"
#include "app/language/language.h"
#include "core/base/version.h"

namespace noonmark {

namespace {

bool scrolls(const QWidget& widget) {
    for (const QWidget* parent = widget.parentWidget(); parent != nullptr; parent = parent->parentWidget())
        if (qobject_cast<const QAbstractScrollArea*>(parent) != nullptr) return true;
    return false;
}

bool isGuarded(const QWidget& widget) {
    return qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr ||
           qobject_cast<const QComboBox*>(&widget) != nullptr ||
           (qobject_cast<const QSlider*>(&widget) != nullptr && scrolls(widget));
}

}  // namespace

WheelGuard::WheelGuard(QApplication& application) : QObject(&application) {
    application.installEventFilter(this);
}

bool WheelGuard::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::Wheel && event->type() != QEvent::Polish) return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr || !isGuarded(*widget)) return false;
    if (event->type() == QEvent::Polish) {
        if (widget->focusPolicy() == Qt::WheelFocus) widget->setFocusPolicy(Qt::StrongFocus);
        return false;
    }
    if (widget->hasFocus()) return false;
    event->ignore();  // goes on to the parent, which scrolls
    return true;
}

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

WindowRenewal::WindowRenewal(QSettings& settings) : settings_(settings) {
    adopt(std::make_unique<MainWindow>(settings_));
}

WindowRenewal::~WindowRenewal() = default;

// Later: the dialog that asks for it belongs to the window.
void WindowRenewal::adopt(std::unique_ptr<MainWindow> window) {
    connect(window.get(), &MainWindow::textsChanged, this, &WindowRenewal::renew, Qt::QueuedConnection);
    std::swap(window_, window);
}

// The new window is there before the old one goes, so that the program does not end between them.
void WindowRenewal::renew() {
    applyLanguage(readLanguage(settings_), *qApp);
    applyUnits(readUnits(settings_));
    auto next = std::make_unique<MainWindow>(settings_, window_->sharedWorkbench());
    next->takeOver(*window_);
    next->show();
    adopt(std::move(next));
    Q_EMIT renewed();
}

}  // namespace noonmark
