// A file geodatabase with bytes of its tables changed: arbitrary bytes are no geodatabase. The input holds
// changes of four bytes each: the file, the offset in it (two bytes) and the new value; an offset beyond the
// end shortens the file to 16 times the value.
#include <fstream>
#include <iterator>
#include <map>

#include "tests/fuzz/file_geodatabase.h"
#include "tests/fuzz/fuzz_file.h"
#include "tests/fuzz/sound.h"

namespace noonmark::tests {

namespace {

using Files = std::map<std::string, std::string>;

const Files& soundGeodatabase() {
    static const Files files = [] {
        const auto town = fuzzFolder() / "town.gdb";
        writeFileGeodatabase(town);
        Files all;
        for (const auto& entry : std::filesystem::directory_iterator(town)) {
            std::ifstream stream(entry.path(), std::ios::binary);
            all["town.gdb/" + entry.path().filename().string()] = {std::istreambuf_iterator<char>(stream),
                                                                   {}};
        }
        return all;
    }();
    return files;
}

void change(std::string& bytes, std::size_t place, std::uint8_t value) {
    if (place < bytes.size())
        bytes[place] = char(value);
    else if (std::size_t(value) * 16 < bytes.size())
        bytes.resize(std::size_t(value) * 16);
}

}  // namespace

}  // namespace noonmark::tests

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace noonmark::tests;
    const Files& sound = soundGeodatabase();
    Files changed;
    for (std::size_t at = 0; at + 4 <= size; at += 4) {
        const auto& [name, bytes] = *std::next(sound.begin(), std::ptrdiff_t(data[at] % sound.size()));
        change(changed.try_emplace(name, bytes).first->second, data[at + 1] + 256U * data[at + 2],
               data[at + 3]);
    }
    for (const auto& [name, bytes] : changed) fuzzFile(name, bytes);
    noonmark::NoProgress progress;
    use(noonmark::readFootprints(fuzzFolder() / "town.gdb", {}, progress, {}));
    for (const auto& [name, bytes] : changed) fuzzFile(name, sound.at(name));
    return 0;
}
