#include "app/window/frame/qt_dates.h"

namespace noonmark {

QDate dateOf(CivilDate date) {
    return {int(date.year()), int(unsigned(date.month())), int(unsigned(date.day()))};
}

CivilDate civilOf(QDate date) {
    return {std::chrono::year{date.year()}, std::chrono::month{unsigned(date.month())},
            std::chrono::day{unsigned(date.day())}};
}

}  // namespace noonmark
