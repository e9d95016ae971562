#include "app/gui/frame/window_renewal.h"

#include <QApplication>
#include <QSettings>

#include "app/gui/base/looks/language.h"
#include "app/gui/base/looks/units.h"
#include "app/gui/frame/main_window.h"

namespace noonmark {

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
