#include "app/window/widgets/number_words.h"

#include "core/base/display_units.h"

namespace noonmark {

QString groupDigits(double number, int decimals) {
    return QString::fromStdString(formatNumber(number, decimals));
}

}  // namespace noonmark
