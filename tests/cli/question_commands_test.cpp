#include "app/cli/commands/question_commands.h"

#include "tests/cli/project_command.h"
#include "tests/shared/toy_question.h"

namespace noonmark::cli::tests {
namespace {

using ::testing::HasSubstr;

/// A command line that has the toy question alone.
struct QuestionCommand : ProjectCommand {
    CommandOutput ask(std::vector<std::string> arguments) {
        static const std::array questions{&test::toyQuestion()};
        CLI::App app;
        cli::Run run;
        addQuestionCommands(app, run, questions);
        std::ranges::reverse(arguments);
        app.parse(arguments);
        std::ostringstream out, err;
        const int code = run({out, err, false});
        return {code, out.str(), err.str()};
    }
    std::vector<std::string> toy() {
        return {"toy",    file_, "--region", "Park",       "--cell", "10",
                "--zone", "UTC", "--start",  "2026-12-21", "--out",  folder_.path("out").string()};
    }
};

TEST_F(QuestionCommand, AsksWritesPrintsAndSaves) {
    auto arguments = toy();
    arguments.insert(arguments.end(), {"--save", "Felled"});
    const CommandOutput output = ask(arguments);
    EXPECT_EQ(output.code, 0) << output.err;
    EXPECT_THAT(output.out, HasSubstr("trees felled"));
    EXPECT_TRUE(std::filesystem::exists(folder_.path("out") / "toy.json"));
    ASSERT_EQ(opened().results.size(), 1U);
    EXPECT_EQ(opened().results[0]->kind, "toy");
}

TEST_F(QuestionCommand, RefusesToReplaceFilesBeforeItComputes) {
    ASSERT_EQ(ask(toy()).code, 0);
    const CommandOutput again = ask(toy());
    EXPECT_EQ(again.code, 2);
    EXPECT_THAT(again.err, HasSubstr("toy.json"));
}

TEST_F(QuestionCommand, PrintsItsJson) {
    auto arguments = toy();
    arguments.emplace_back("--json");
    EXPECT_TRUE(ask(arguments).json().contains("trees_felled"));
}

}  // namespace
}  // namespace noonmark::cli::tests
