#include "app/cli/offscreen_qt.h"

#include <fmt/format.h>

#include <QApplication>
#include <clocale>
#include <cstdio>

namespace noonmark::cli {

namespace {

void onQtMessage(QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtCriticalMsg || type == QtFatalMsg) fmt::print(stderr, "{}\n", message.toStdString());
}

}  // namespace

OffscreenQt::OffscreenQt() {
    qInstallMessageHandler(onQtMessage);
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
    if (QCoreApplication::instance() == nullptr) application_ = std::make_unique<QApplication>(argc_, argv_);
    // Qt took the decimal comma of the system for C functions too, which read and write files.
    std::setlocale(LC_NUMERIC, "C");
}

OffscreenQt::~OffscreenQt() = default;

}  // namespace noonmark::cli
