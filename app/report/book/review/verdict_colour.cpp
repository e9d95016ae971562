#include "app/report/book/review/verdict_colour.h"

#include "app/report/maps/style.h"

namespace noonmark {

QColor verdictMark(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return {0x00, 0x9e, 0x73};
        case Verdict::borderline:
            return {0xe6, 0x9f, 0x00};
        case Verdict::fail:
            return {0xb0, 0x2a, 0x1a};
        case Verdict::notApplicable:
        case Verdict::notChecked:
            break;
    }
    return ink::line;
}

}  // namespace noonmark
