#include "core/io/footprints/place_advice.h"

namespace noonmark {

bool asksForPlace(const Error& error) {
    return error.advice.starts_with(crsAdvice) || error.advice.starts_with(anchorAdvice);
}

}  // namespace noonmark
