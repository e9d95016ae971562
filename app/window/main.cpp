#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <iostream>

#include "app/window/frame/appearance.h"
#include "app/window/frame/heap_settings.h"
#include "app/window/frame/main_window.h"
#include "core/simd/instruction_set.h"

int main(int argc, char** argv) {
    if (const auto chosen = noonmark::useInstructionSetOfEnvironment(); !chosen) {
        std::cerr << "noonmark: " << chosen.error().text() << '\n';
        return 2;
    }
    noonmark::returnFreedMemory();
    noonmark::chooseRenderer();
    QApplication application(argc, argv);
    noonmark::applyAppearance(application);
    QCommandLineParser parser;
    parser.setApplicationDescription(QStringLiteral("Measures the shadows of buildings on a city"));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(QStringLiteral("files"),
                                 QStringLiteral("City files, or sample:central-park-south, sample:grid"));
    parser.process(application);

    QSettings settings;
    noonmark::MainWindow window(settings);
    window.show();
    const QStringList files = parser.positionalArguments();
    window.open(files.isEmpty() ? QStringList{QStringLiteral("sample:central-park-south")} : files);
    return QApplication::exec();
}
