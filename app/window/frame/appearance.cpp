#include "app/window/frame/appearance.h"

#include <QApplication>
#include <QIcon>
#include <QPalette>
#include <QStyleFactory>

#include "core/base/version.h"

namespace noonmark {

namespace {

QPalette lightPalette() {
    QPalette palette(QColor(0xf6, 0xf7, 0xf8));
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::Text, QColor(0x1d, 0x20, 0x27));
    palette.setColor(QPalette::WindowText, QColor(0x1d, 0x20, 0x27));
    palette.setColor(QPalette::Highlight, QColor(0x2f, 0x5f, 0x9e));
    palette.setColor(QPalette::HighlightedText, Qt::white);
    palette.setColor(QPalette::PlaceholderText, QColor(0x5c, 0x61, 0x6b));
    for (const auto role : {QPalette::Text, QPalette::WindowText})
        palette.setColor(QPalette::Disabled, role, QColor(0x9a, 0x9e, 0xa6));
    return palette;
}

}  // namespace

void chooseRenderer() {
    if (!qEnvironmentVariableIsSet("QT3D_RENDERER")) qputenv("QT3D_RENDERER", "opengl");
}

void applyAppearance(QApplication& application) {
    QApplication::setOrganizationName(QStringLiteral("Noonmark"));
    QApplication::setApplicationName(QStringLiteral("Noonmark"));
    QApplication::setApplicationVersion(QString::fromUtf8(version().data(), qsizetype(version().size())));
    // The desktop finds the window's name and icon by it (resources/desktop).
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.noonmark.Noonmark"));
    QApplication::setWindowIcon(QIcon::fromTheme(QStringLiteral("io.github.noonmark.Noonmark")));
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    application.setPalette(lightPalette());
}

}  // namespace noonmark
