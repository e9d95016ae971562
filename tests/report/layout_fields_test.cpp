#include "app/report/book/book.h"
#include "tests/shared/changed_fields.h"

namespace noonmark {
namespace {

using namespace tests;

// A member that is added needs a row in its table; then this number grows with it.
static_assert(countMembers<PageSetup>() == 2);
static_assert(countMembers<BookSettings>() == 9);

TEST(SettingsFields, NoneOfTheLayoutOfSheetsIsForgotten) {
    expectNoticed(pageFields(), PageSetup{});
    expectNoticed(scaleFields(), BookSettings{});
    expectNoticed(bookFields(), BookSettings{});
    expectNoticed(extentFields(), BookSettings{});
}

}  // namespace
}  // namespace noonmark
