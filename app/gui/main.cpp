#include <QApplication>
#include <QSettings>
#include <iostream>
#include <optional>
#include <string_view>

#include "app/gui/base/jobs/job.h"
#include "app/gui/frame/help/start_page.h"
#include "app/gui/frame/main_window.h"
#include "app/gui/frame/window_start.h"
#include "app/input/window_arguments.h"
#include "core/base/process.h"
#include "core/simd/instruction_set.h"

namespace {

// Fills `arguments`, or returns the exit code if the program ends here: help, version, a wrong argument.
std::optional<int> parse(int argc, const char* const* argv, noonmark::WindowArguments& arguments) {
    CLI::App program;
    noonmark::addWindowArguments(program, arguments);
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& information) {
        return program.exit(information);
    } catch (const CLI::ParseError& error) {
        std::cerr << "noonmark: " << error.what() << " (--help shows the options)\n";
        return 2;
    }
    return std::nullopt;
}

// Questions about the program that need no display.
bool asksAboutProgram(int argc, const char* const* argv) {
    const std::string_view first = argc == 2 ? argv[1] : "";
    return first == "-h" || first == "--help" || first == "-v" || first == "--version";
}

QStringList filesOf(const noonmark::WindowArguments& arguments) {
    QStringList files;
    for (const std::string& file : arguments.files) files << QString::fromStdString(file);
    return files.isEmpty() ? QStringList{QStringLiteral("sample:central-park-south")} : files;
}

// What Qt warns of tells its developers something, and users nothing.
void reportQt(QtMsgType type, const QMessageLogContext&, const QString& message) {
    static const bool all = qEnvironmentVariableIsSet("QT_LOGGING_RULES");
    if (all || type == QtCriticalMsg || type == QtFatalMsg) std::cerr << message.toStdString() << '\n';
}

int run(int argc, char** argv) {
    noonmark::WindowArguments arguments;
    if (const auto chosen = noonmark::useInstructionSetOfEnvironment(); !chosen) {
        std::cerr << "noonmark: " << chosen.error().text() << '\n';
        return 2;
    }
    noonmark::ignoreFileSizeSignal();
    if (asksAboutProgram(argc, argv)) return parse(argc, argv, arguments).value_or(0);
    noonmark::returnLargeBlocks();
    noonmark::chooseRenderer();
    qInstallMessageHandler(reportQt);
    QApplication application(argc, argv);  // takes the options that are Qt's, such as -platform
    if (const auto code = parse(argc, argv, arguments)) return *code;
    noonmark::applyAppearance(application);

    QSettings settings;
    noonmark::WindowRenewal renewal(settings);
    noonmark::MainWindow& window = renewal.window();
    window.show();
    window.open(filesOf(arguments));
    if (arguments.files.empty() && noonmark::readShowStart(settings)) window.help().showStart(false);
    return QApplication::exec();
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "noonmark: " << error.what() << '\n';
        return 1;
    }
}
