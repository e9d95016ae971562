#include <fmt/core.h>
#include <malloc.h>

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QStandardPaths>
#include <algorithm>
#include <fstream>

#include "app/gui/base/jobs/job.h"
#include "app/gui/frame/window_start.h"
#include "tests/soak/window_user.h"

/// Performs random actions in the window for a while and writes the memory use as CSV, one line per minute.
namespace noonmark::soak {
namespace {

constexpr double megabyte = 1e6;
constexpr int editsOfOneDrag = 25;
constexpr double openedEveryMinutes = 5;

/// Resident memory of the process, MB (proc(5): the second number of statm, in pages).
double residentMb() {
    std::ifstream file("/proc/self/statm");
    double size = 0;
    double resident = 0;
    file >> size >> resident;
    return resident * 4096 / megabyte;
}

/// Heap memory in use by the program, MB.
double heapMb() {
    const auto info = mallinfo2();
    return double(info.uordblks + info.hblkhd) / megabyte;
}

/// What a line was measured after.
enum class After { use, opening };

void writeLine(double minutes, long actions, int liveEdits, After after) {
    fmt::print("{:.1f},{},{},{:.1f},{:.1f},{}\n", minutes, actions, liveEdits, residentMb(), heapMb(),
               after == After::use ? "use" : "opening");
    std::fflush(stdout);
}

// Opening a city forgets the scenarios, the results and the cached horizons. A study of the mode begins anew
// and may hold memory then: a leak shows as a rise of the least that is held.
int soak(const QString& city, double minutes, int liveEdits, unsigned seed) {
    WindowUser user(city, seed);
    QElapsedTimer clock;
    clock.start();
    const auto passed = [&clock] { return double(clock.elapsed()) / 60000.0; };
    fmt::print("minutes,actions,live edits,resident MB,heap MB,after\n");
    double next = 1;
    double nextOpening = 0;
    long actions = 0;
    while (passed() < minutes || user.liveEdits() < liveEdits) {
        if (passed() >= nextOpening) {
            user.openAgain();
            writeLine(passed(), actions, user.liveEdits(), After::opening);
            nextOpening += openedEveryMinutes;
        }
        if (passed() >= next) {
            writeLine(passed(), actions, user.liveEdits(), After::use);
            next += 1;
        }
        // The live edits are spread over the time, between other actions, so that both take effect together.
        if (user.liveEdits() < liveEdits * std::min(1.0, passed() / minutes)) user.dragTower(editsOfOneDrag);
        if (passed() < minutes) user.act();
        ++actions;
    }
    user.openAgain();
    writeLine(passed(), actions, user.liveEdits(), After::opening);
    return 0;
}

}  // namespace
}  // namespace noonmark::soak

int main(int argc, char** argv) {
    noonmark::returnLargeBlocks();
    noonmark::chooseRenderer();
    QApplication application(argc, argv);
    QStandardPaths::setTestModeEnabled(true);  // leaves nothing in the user's folders
    noonmark::applyAppearance(application);
    QCommandLineParser parser;
    parser.addHelpOption();
    const QCommandLineOption minutes("minutes", "How long the window is used by chance.", "minutes", "60");
    const QCommandLineOption edits("live-edits", "At least so many edits of a tower with its shadow.",
                                   "edits", "10000");
    const QCommandLineOption seed("seed", "Of the chance.", "seed", "1");
    parser.addOptions({minutes, edits, seed});
    parser.addPositionalArgument("city", "A city file, or sample:central-park-south");
    parser.process(application);
    const QStringList files = parser.positionalArguments();
    return noonmark::soak::soak(files.isEmpty() ? QStringLiteral("sample:central-park-south") : files.first(),
                                parser.value(minutes).toDouble(), parser.value(edits).toInt(),
                                parser.value(seed).toUInt());
}
