#include "app/cli/base/offscreen_qt.h"

#include <fmt/format.h>

#include <QApplication>
#include <array>
#include <clocale>
#include <cstdio>

namespace noonmark::cli {

namespace {

void onQtMessage(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtCriticalMsg || type == QtFatalMsg) fmt::print(stderr, "{}\n", message.toStdString());
}

// What a desktop sets for windows: its platform may be missing here, which would end the process, its theme
// may want a display, and its scale and resolution would change what is drawn into files.
constexpr std::array desktopVariables{"QT_QPA_PLATFORMTHEME",
                                      "QT_STYLE_OVERRIDE",
                                      "QT_SCALE_FACTOR",
                                      "QT_SCREEN_SCALE_FACTORS",
                                      "QT_FONT_DPI",
                                      "QT_USE_PHYSICAL_DPI",
                                      "QT_AUTO_SCREEN_SCALE_FACTOR",
                                      "QT_ENABLE_HIGHDPI_SCALING"};

void leaveDesktop() {
    for (const char* variable : desktopVariables) qunsetenv(variable);
    qputenv("QT_QPA_PLATFORM", "offscreen");
}

}  // namespace

OffscreenQt::OffscreenQt() {
    qInstallMessageHandler(onQtMessage);
    leaveDesktop();
    if (QCoreApplication::instance() == nullptr) application_ = std::make_unique<QApplication>(argc_, argv_);
    // Qt took the decimal comma of the system for C functions too, which read and write files.
    std::setlocale(LC_NUMERIC, "C");
}

OffscreenQt::~OffscreenQt() = default;

}  // namespace noonmark::cli
