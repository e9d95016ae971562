#include "app/gui/base/looks/application_theme.h"

#include <QApplication>
#include <QEvent>
#include <utility>

namespace noonmark {

ApplicationTheme::ApplicationTheme(QApplication& application, ThemeChoice choice, const QPalette& system,
                                   std::unique_ptr<ThemeSource> desktop)
    : QObject(&application), choice_(choice), system_(system), desktop_(std::move(desktop)) {
    application.installEventFilter(this);
    if (desktop_) connect(desktop_.get(), &ThemeSource::changed, this, &ApplicationTheme::apply);
    apply();
}

ApplicationTheme* ApplicationTheme::inUse() {
    return qApp->findChild<ApplicationTheme*>(QString(), Qt::FindDirectChildrenOnly);
}

void ApplicationTheme::choose(ThemeChoice choice) {
    choice_ = choice;
    apply();
}

// The platform tells each window; one answer is enough.
bool ApplicationTheme::eventFilter(QObject*, QEvent* event) {
    if (event->type() == QEvent::ThemeChange && !std::exchange(paletteChanged_, true))
        QMetaObject::invokeMethod(this, &ApplicationTheme::readPalette, Qt::QueuedConnection);
    return false;
}

// The platform's palette shows only while the application has none of its own.
void ApplicationTheme::readPalette() {
    paletteChanged_ = false;
    QApplication::setPalette(QPalette());
    system_ = QApplication::palette();
    apply();
}

void ApplicationTheme::apply() {
    const auto stated = desktop_ ? desktop_->theme() : std::nullopt;
    applyTheme(choice_, stated ? makePalette(*stated) : system_);
}

}  // namespace noonmark
