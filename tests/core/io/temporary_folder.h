#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace noonmark::tests {

/// A folder of its own for a test that writes files; gone with the test.
class TemporaryFolder {
public:
    TemporaryFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string("noonmark_") + test->test_suite_name() + "_" + test->name() + "_" +
                   std::to_string(std::hash<const void*>{}(this)));
        std::filesystem::create_directories(folder_);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }

    [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_ / name; }

    /// Writes a file and says where it is.
    [[nodiscard]] std::filesystem::path file(const std::string& name, std::string_view content) const {
        std::ofstream(path(name), std::ios::binary).write(content.data(), std::streamsize(content.size()));
        return path(name);
    }

private:
    std::filesystem::path folder_;
};

}  // namespace noonmark::tests
