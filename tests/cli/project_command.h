#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "scenarios/project/project_file.h"
#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark::cli::tests {

/// A fixture with a project of the sample, without its places, in its own folder.
class ProjectCommand : public testing::Test {
protected:
    void SetUp() override {
        const CommandOutput made = noonmarkCli({"project", "new", file_, "sample:central-park-south"});
        ASSERT_EQ(made.code, 0) << made.err;
        EXPECT_THAT(made.out, testing::HasSubstr("1 region, 7 lots"));
        removePlaces();
    }

    /// `command` may have several words: "lot add".
    CommandOutput project(const std::string& command, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{"project"};
        std::istringstream words(command);
        for (std::string word; words >> word;) arguments.push_back(word);
        arguments.push_back(file_);
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    }

    /// Runs a command that must succeed. Returns its output.
    std::string done(const std::string& command, const std::vector<std::string>& more) {
        const CommandOutput output = project(command, more);
        EXPECT_EQ(output.code, 0) << command << ": " << output.err;
        return output.out;
    }

    /// Runs a command that must be refused and must leave the file unchanged. Returns the error.
    std::string refused(const std::string& command, const std::vector<std::string>& more) {
        const auto before = ProjectFile::open(file_).value().saves();
        const CommandOutput output = project(command, more);
        EXPECT_EQ(output.code, 2) << command << ": " << output.out;
        EXPECT_EQ(ProjectFile::open(file_).value().saves(), before) << command;
        return output.err;
    }

    CommandOutput measured(const std::string& command, const std::vector<std::string>& more) {
        std::vector<std::string> arguments{command,       file_,    "--region",
                                           "Park",        "--cell", "10",
                                           "--overwrite", "--out",  folder_.path("out").string()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return noonmarkCli(arguments);
    }

    /// Measures one hour in December.
    CommandOutput atNoon(const std::string& command, std::vector<std::string> more) {
        for (const char* word : {"--start", "2026-12-21", "--at", "12:00", "--hours", "1", "--step", "10",
                                 "--zone", "America/New_York"})
            more.emplace_back(word);
        return measured(command, more);
    }

    /// Tests add places of their own to those of the sample, which are hundreds.
    void removePlaces() {
        ProjectFile disk = ProjectFile::open(file_).value();
        Project project = disk.project();
        project.places.clear();
        ASSERT_TRUE(disk.save(project));
    }

    [[nodiscard]] Project opened() const { return ProjectFile::open(file_).value().project(); }

    noonmark::tests::TemporaryFolder folder_;
    std::string file_ = folder_.path("park.noonmark.gpkg").string();
};

}  // namespace noonmark::cli::tests
