// noonmark-cli: answers --help by itself and starts noonmark-commands for everything else. The libraries of
// that program, most of them GDAL's and Qt's, take a hundred milliseconds to load; help takes one.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "app/launcher/help_texts.h"

namespace noonmark::launcher {

namespace {

constexpr int exitFailed = 1;
constexpr const char* program = "noonmark-commands";

// The words "project new" of `project new --help`, with a space before each; false if something else is asked
// for. An environment that chooses an instruction set is checked by the program first.
bool asksForHelp(int argc, char** argv) {
    if (argc < 2 || std::getenv("NOONMARK_ISA") != nullptr) return false;
    const std::string_view last = argv[argc - 1];
    return last == "--help" || last == "-h";
}

bool isCommand(std::string_view words, int argc, char** argv) {
    for (int i = 1; i < argc - 1; ++i) {
        const std::string_view word = argv[i];
        if (!words.starts_with(word)) return false;
        words.remove_prefix(word.size());
        if (i + 1 == argc - 1) return words.empty();
        if (!words.starts_with(' ')) return false;
        words.remove_prefix(1);
    }
    return words.empty();
}

const HelpText* findHelp(int argc, char** argv) {
    for (const HelpText& help : helpTexts())
        if (isCommand(help.words, argc, argv)) return &help;
    return nullptr;
}

int print(std::string_view text) {
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (written && std::fflush(stdout) == 0) return 0;
    std::fputs(
        "noonmark-cli: The output could not be written completely. Check that the disk has free space\n",
        stderr);
    return exitFailed;
}

// Replaces this process by the program in a folder; returns if it is not there.
void start(std::string_view folder, const char* below, char** argv) {
    std::array<char, PATH_MAX> path{};
    const int length = std::snprintf(path.data(), path.size(), "%.*s/%s%s", int(folder.size()), folder.data(),
                                     below, program);
    if (length > 0 && std::size_t(length) < path.size()) ::execv(path.data(), argv);
}

int startProgram(char** argv) {
    std::array<char, PATH_MAX> self{};
    const ssize_t length = ::readlink("/proc/self/exe", self.data(), self.size() - 1);
    std::string_view folder(self.data(), length > 0 ? std::size_t(length) : 0);
    folder = folder.substr(0, folder.rfind('/'));
    start(folder, "", argv);
    start(folder, NOONMARK_HELPER_FOLDER "/", argv);
    std::fprintf(stderr, "noonmark-cli: %s is missing beside it. Install Noonmark again\n", program);
    return exitFailed;
}

}  // namespace

}  // namespace noonmark::launcher

// `noonmark-cli help study` asks the same as `noonmark-cli study --help`.
int main(int argc, char** argv) {
    using namespace noonmark::launcher;
    static char helpOption[] = "--help";
    if (argc > 1 && std::strcmp(argv[1], "help") == 0) {
        std::rotate(argv + 1, argv + 2, argv + argc);
        argv[argc - 1] = helpOption;
    }
    if (asksForHelp(argc, argv))
        if (const HelpText* help = findHelp(argc, argv)) return print(help->text);
    return startProgram(argv);
}
