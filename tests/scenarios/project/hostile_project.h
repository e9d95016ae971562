#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/project/project_file.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/scenarios/sample_project.h"

namespace noonmark::tests {

/// Rows of text; empty for statements that return no rows.
using Rows = std::vector<std::vector<std::string>>;

inline int keepRow(void* rows, int columns, char** values, char**) {
    auto& row = static_cast<Rows*>(rows)->emplace_back();
    for (int i = 0; i < columns; ++i) row.emplace_back(values[i] != nullptr ? values[i] : "");
    return 0;
}

class HostileProject : public testing::Test {
protected:
    void SetUp() override { remake(); }

    void remake() {
        std::filesystem::remove(file());
        ASSERT_TRUE(ProjectFile::create(file(), sampleProject()));
    }
    [[nodiscard]] std::filesystem::path file() const { return folder_.path("town.noonmark.gpkg"); }

    /// Executes statements as any SQLite program would; refused statements change nothing.
    Rows sql(const std::string& statements) const {
        sqlite3* database = nullptr;
        sqlite3_open(file().c_str(), &database);
        Rows rows;
        sqlite3_exec(database, statements.c_str(), keepRow, &rows, nullptr);
        sqlite3_close(database);
        return rows;
    }

    /// The error of opening the file; empty if it opens.
    [[nodiscard]] std::string error() const {
        const auto opened = ProjectFile::open(file());
        return opened ? "" : opened.error().text();
    }

    void expectRefused(const std::string& statements, const std::string& about) {
        sql(statements);
        EXPECT_THAT(error(), testing::HasSubstr(about)) << statements;
        remake();
    }

    TemporaryFolder folder_;
};

}  // namespace noonmark::tests
