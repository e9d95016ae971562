#include "app/report/maps/verdict_colour.h"

namespace noonmark {

QColor verdictMark(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return {0x2b, 0x83, 0xba};
        case Verdict::borderline:
            return {0xf7, 0xdc, 0x3c};
        case Verdict::fail:
            return {0xa8, 0x2a, 0x0a};
        case Verdict::notApplicable:
        case Verdict::notChecked:
            break;
    }
    return {0xd5, 0xd7, 0xda};
}

}  // namespace noonmark
