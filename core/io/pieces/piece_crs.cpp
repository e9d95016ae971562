#include "core/io/pieces/read_part.h"
#include "core/io/settings/read_fields.h"

namespace noonmark {

std::string describeCrs(const std::string& name, CrsSource source) {
    if (source == CrsSource::file) return name + ", as the file states";
    if (source == CrsSource::user) return name + ", as " + readOption("crs") + " states";
    return name + ", guessed from the numbers";
}

}  // namespace noonmark
