#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "app/cli/describe/describe.h"
#include "app/input/build_facts.h"
#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::cli::tests {
namespace {

using noonmark::tests::readBytes;
using noonmark::tests::TemporaryFolder;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

// Standard output of a shell's command, by words.
std::vector<std::string> wordsOf(const std::string& command) {
    std::vector<std::string> words;
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return words;
    std::string text;
    std::array<char, 4096> part{};
    for (std::size_t size = 0; (size = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
        text.append(part.data(), size);
    pclose(pipe);
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

bool hasShell(const std::string& name) {
    return std::system(("command -v " + name + " >/dev/null").c_str()) == 0;
}

/// Two commands, one nested, with an option of each kind.
struct SmallProgram {
    CLI::App app{"Does something.", "small"};

    SmallProgram() {
        CLI::App* work = app.add_subcommand("work", "Work on files");
        work->add_option("files", "Files to work on")->required()->type_name("FILE")->expected(1, 1000);
        work->add_option("--unit", "The unit")
            ->check(CLI::IsMember({"m", "ft"}))
            ->type_name("UNIT")
            ->default_str("m");
        work->add_option("--days", "Number of days")->check(CLI::Range(1, 3660))->type_name("N");
        work->add_option("--at", "The time")->type_name("HH:MM");
        work->add_option("--place", "A place")->type_name("W,S,E,N|FILE|city");
        work->add_flag_callback("--hidden", [] {})->group("");
        work->add_option_group("more")->add_flag_callback(
            "--json", [] {}, "Print JSON");
        app.add_subcommand("group", "A group")->add_subcommand("new", "Something new: it's [here]");
        app.add_subcommand("secret", "Not shown")->group("");
    }
};

const OptionDescription& option(const CommandDescription& command, const std::string& name) {
    for (const OptionDescription& option : command.options)
        if (option.names.back() == name) return option;
    throw std::runtime_error("no option " + name);
}

TEST(DescribeProgram, ReadsCommandsOptionsAndWhatTheyTake) {
    const SmallProgram small;
    const CommandDescription program = describeProgram(small.app);
    ASSERT_EQ(program.commands.size(), 2U);
    const CommandDescription& work = program.commands[0];
    EXPECT_THAT(option(work, "--unit").value.choices, ElementsAre("m", "ft"));
    EXPECT_EQ(option(work, "--unit").value.name, "UNIT");
    EXPECT_EQ(option(work, "--unit").defaultValue, "m");
    EXPECT_EQ(option(work, "--days").value.name, "N");
    EXPECT_EQ(option(work, "--days").value.limits, "1 to 3660");
    EXPECT_EQ(option(work, "--at").value.name, "HH:MM");
    EXPECT_THAT(option(work, "--place").value.choices, ElementsAre("city"));
    EXPECT_TRUE(option(work, "--place").value.takesFiles);
    EXPECT_EQ(option(work, "--json").text, "Print JSON");
    EXPECT_EQ(work.options.size(), 6U) << "--help and the five shown";
    ASSERT_EQ(work.positionals.size(), 1U);
    EXPECT_TRUE(work.positionals[0].required && work.positionals[0].repeats &&
                work.positionals[0].value.takesFiles);
    EXPECT_EQ(commandPath(program.commands[1].commands[0], "/"), "group/new");
}

TEST(DescribeProgram, TextsOfHelpCannotBreakTheFormats) {
    const SmallProgram small;
    const CommandDescription program = describeProgram(small.app);
    EXPECT_THAT(writeZshCompletion(program).text, HasSubstr("'new:Something new\\: it'\\''s \\[here\\]'"));
    EXPECT_THAT(writeFishCompletion(program).text, HasSubstr("-a new -d 'Something new: it\\'s [here]'"));
}

TEST(DescribeProgram, LinesOfAManualStartWithNoRequestByChance) {
    CLI::App app("Does something.", "small");
    app.add_option("--end", "Ending of names:\n.tif or 'none' \\ -x")->type_name("TEXT");
    const std::string page = writeManualPages(describeProgram(app), {"1.0", "2026-11-24", {}, {}})[0].text;
    EXPECT_THAT(page, HasSubstr("\\fB\\-\\-end\\fR \\fITEXT\\fR\n"));
    EXPECT_THAT(page, HasSubstr("names: \\&.tif or \\&'none' \\e \\-x."));
}

/// All files of all formats, as the build writes them.
class Descriptions : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder_ = new TemporaryFolder;
        for (const char* format : {"man", "bash", "zsh", "fish"})
            ASSERT_EQ(noonmarkCli({"describe", format, "--out", folder_->path("").string()}).code, exitOk);
    }
    static void TearDownTestSuite() { delete folder_; }

    static std::filesystem::path file(const std::string& name) { return folder_->path(name); }

    /// What bash offers for the last of the words.
    static std::vector<std::string> bashOffers(const std::vector<std::string>& words) {
        std::string array;
        for (const std::string& word : words) array += " '" + word + "'";
        return wordsOf("cd " + folder_->path("").string() +
                       " && bash -c '. ./noonmark-cli; COMP_WORDS=(noonmark-cli" + quoted(array) +
                       "); COMP_CWORD=" + std::to_string(words.size()) +
                       "; _noonmark_cli; printf \"%s\\n\" \"${COMPREPLY[@]}\"'");
    }

private:
    static std::string quoted(const std::string& text) {
        std::string escaped;
        for (const char c : text) escaped += c == '\'' ? std::string("'\\''") : std::string(1, c);
        return escaped;
    }

    static TemporaryFolder* folder_;
};

TemporaryFolder* Descriptions::folder_ = nullptr;

// The help of each command, which the parser writes by itself, against each description.
TEST_F(Descriptions, NameEveryCommandAndOption) {
    CLI::App app("", "noonmark-cli");
    const std::string bash = readBytes(file("noonmark-cli"));
    const std::string zsh = readBytes(file("_noonmark-cli"));
    const std::string fish = readBytes(file("noonmark-cli.fish"));
    const std::string help = noonmarkCli({"--help"}).out;
    std::istringstream lines(help.substr(help.find("Subcommands:\n") + 13));
    int commands = 0;
    for (std::string line; std::getline(lines, line) && line.starts_with("  "); ++commands) {
        const std::string name = line.substr(2, line.find(' ', 2) - 2);
        const std::string page = readBytes(file("noonmark-cli-" + name + ".1"));
        EXPECT_THAT(bash, HasSubstr("'/" + name + "') options=")) << name;
        EXPECT_THAT(zsh, HasSubstr("_noonmark-cli-" + name + "() {")) << name;
        EXPECT_THAT(fish, HasSubstr(" -a " + name + " -d ")) << name;
        std::istringstream helpLines(noonmarkCli({name, "--help"}).out);
        for (std::string helpLine; std::getline(helpLines, helpLine);) {
            std::string word;  // an option is the first one of its line; later ones may be another program's
            std::istringstream(helpLine) >> word;
            if (!word.starts_with("--") || word.size() < 4) continue;
            word = word.substr(0, word.find_first_of(",.;:)'"));
            std::string escaped;
            for (const char c : word) escaped += c == '-' ? std::string("\\-") : std::string(1, c);
            EXPECT_THAT(page, HasSubstr(escaped)) << name;
            EXPECT_THAT(bash, HasSubstr(word)) << name;
            EXPECT_THAT(zsh, HasSubstr(word)) << name;
            EXPECT_THAT(fish, HasSubstr(" -l " + word.substr(2))) << name;
        }
    }
    EXPECT_GE(commands, 17);
    EXPECT_THAT(bash + zsh + fish, Not(HasSubstr("/describe")));
}

TEST_F(Descriptions, PagesStateVersionDateAndExitCodes) {
    const std::string page = readBytes(file("noonmark-cli.1"));
    EXPECT_THAT(page, HasSubstr(".TH NOONMARK-CLI 1 " + std::string(buildFacts().releaseDate)));
    EXPECT_THAT(page, HasSubstr(".SH \"EXIT STATUS\""));
    EXPECT_THAT(readBytes(file("noonmark.1")), HasSubstr("\\fIfiles\\fR"));
}

TEST_F(Descriptions, BashCompletesCommandsAndOptions) {
    EXPECT_THAT(bashOffers({"st"}), ElementsAre("study"));
    EXPECT_THAT(bashOffers({""}), IsSupersetOf({"study", "project", "review"}));
    EXPECT_THAT(bashOffers({"project", "ne"}), ElementsAre("new"));
    EXPECT_THAT(bashOffers({"project", "lot", ""}), IsSupersetOf({"add", "list"}));
    EXPECT_THAT(bashOffers({"study", "--height"}),
                testing::UnorderedElementsAre("--height-field", "--height-map", "--height-unit",
                                              "--heights-from-surface"));
    EXPECT_THAT(bashOffers({"sun", "--sce"}), testing::IsEmpty());
}

TEST_F(Descriptions, BashCompletesWhatAnOptionTakes) {
    EXPECT_THAT(bashOffers({"study", "--receivers", ""}),
                testing::UnorderedElementsAre("ground", "roofs", "both", "facades", "windows", "plane",
                                              "lines", "points"));
    EXPECT_THAT(bashOffers({"study", "--receivers", "=", "ro"}), ElementsAre("roofs"))
        << "--receivers=ro, as bash splits it";
    EXPECT_THAT(bashOffers({"study", "--engine", "hor"}), ElementsAre("horizon"));
    EXPECT_THAT(bashOffers({"review", "show", "ce"}), ElementsAre("ceqr"));
    EXPECT_THAT(bashOffers({"study", "--days", ""}), testing::IsEmpty());
    EXPECT_THAT(bashOffers({"info", "noonmark-cli-sun"}), ElementsAre("noonmark-cli-sun.1"));
    EXPECT_THAT(bashOffers({"study", "--out", "project", "--receivers", "r"}), ElementsAre("roofs"))
        << "a folder that is named like a command";
}

TEST_F(Descriptions, FishCompletes) {
    if (!hasShell("fish")) GTEST_SKIP() << "fish is not installed";
    const auto offers = [](const std::string& line) {
        return wordsOf("HOME=/nonexistent fish --no-config -c \"source " +
                       file("noonmark-cli.fish").string() + "; complete -C '" + line + "'\" 2>/dev/null");
    };
    EXPECT_THAT(offers("noonmark-cli stu"), Contains("study"));
    EXPECT_THAT(offers("noonmark-cli project ne"), Contains("new"));
    EXPECT_THAT(offers("noonmark-cli project "), Not(Contains("study")));
    EXPECT_THAT(offers("noonmark-cli study --receivers ro"), Contains("roofs"));
}

TEST_F(Descriptions, ShellsAndManualReadersFindNoMistake) {
    const auto clean = [](const std::string& tool, const std::string& arguments) {
        if (!hasShell(tool)) return true;
        return std::system((tool + " " + arguments + " >/dev/null 2>&1").c_str()) == 0;
    };
    const std::string folder = file("").string();
    EXPECT_TRUE(clean("bash", "-n " + folder + "noonmark-cli"));
    EXPECT_TRUE(clean("zsh", "-n " + folder + "_noonmark-cli"));
    EXPECT_TRUE(clean("fish", "-n " + folder + "noonmark-cli.fish"));
    EXPECT_TRUE(clean("mandoc", "-T lint " + folder + "noonmark*.1"));
}

TEST(Usage, VersionStatesHowTheProgramWasBuilt) {
    const std::string text = noonmarkCli({"--version"}).out;
    EXPECT_THAT(text, StartsWith("Noonmark 0."));
    for (const char* fact : {"Commit: ", "GDAL 3", "Embree 3", "Qt 6", "Instruction sets: ", "in use: "})
        EXPECT_THAT(text, HasSubstr(fact));
}

// noonmark-cli prints these texts in place of the program (app/launcher). Where an option excludes two
// others, CLI11 lists those in the order of their addresses: such commands are not compared.
TEST(HelpSource, HoldsWhatTheProgramPrints) {
    const std::string source = noonmarkCli({"describe", "help"}).out;
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {}, {"project"}, {"project", "new"}, {"tiles", "run"}, {"review", "list"}}) {
        std::vector<std::string> asked = words;
        asked.emplace_back("--help");
        const std::string joined = joinWords(words, " ");
        EXPECT_THAT(source, HasSubstr("{\"" + joined + "\", R\"help(" + noonmarkCli(asked).out + ")help\"}"))
            << joined;
    }
}

}  // namespace
}  // namespace noonmark::cli::tests
