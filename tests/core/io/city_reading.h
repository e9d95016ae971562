#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

#include "core/io/read_city.h"

namespace noonmark::tests {

/// Tests that read files into a city by settings of their own.
class CityReading : public testing::Test {
protected:
    /// The city of the files. A failure to read them fails the test.
    CityRead read(const std::vector<std::filesystem::path>& files) {
        NoProgress quiet;
        auto result = readCity(files, settings, quiet, {});
        EXPECT_TRUE(result) << result.error().text();
        return result ? *std::move(result) : CityRead();
    }

    ReadSettings settings;
};

}  // namespace noonmark::tests
