#include "app/gui/docks/review/verdict_table.h"

#include <QApplication>
#include <QHeaderView>
#include <QObject>
#include <QSignalBlocker>
#include <QStringList>
#include <algorithm>
#include <array>
#include <map>
#include <numeric>

#include "app/gui/base/looks/theme.h"
#include "app/gui/base/widgets/error_text.h"
#include "app/gui/base/widgets/name_text.h"
#include "app/gui/base/widgets/number_text.h"
#include "app/gui/docks/review/review_cache.h"
#include "app/gui/session/answers/result_rows.h"
#include "app/gui/session/study/region_text.h"
#include "core/review/library/rule_text.h"
#include "core/review/places/review_columns.h"
#include "core/review/places/verdict_text.h"
#include "core/review/rule/rule_names.h"

namespace noonmark {

namespace {

constexpr std::array shownOrder{Verdict::fail, Verdict::borderline, Verdict::pass, Verdict::notApplicable,
                                Verdict::notChecked};

void addCount(QStringList& parts, std::size_t count, Verdict verdict) {
    if (count > 0) parts << QStringLiteral("%1 %2").arg(formatCount(count), describeVerdict(verdict));
}

}  // namespace

QString describeVerdict(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return QObject::tr("✓ pass");
        case Verdict::borderline:
            return QObject::tr("≈ borderline");
        case Verdict::fail:
            return QObject::tr("✗ fail");
        case Verdict::notApplicable:
            return QObject::tr("– not applicable");
        case Verdict::notChecked:
            return QObject::tr("? not checked");
    }
    return {};
}

std::string writeDay(CivilDate day) { return QLocale().toString(dateOf(day), dayOfYear()).toStdString(); }

QString describeVerdict(const PlaceReview& review) {
    if (review.reasonNotJudged == noLimitForPlace) return QObject::tr("– figures only");
    return describeVerdict(review.verdict);
}

QString describeCounts(const VerdictCounts& counts) {
    QStringList parts;
    addCount(parts, counts.fail, Verdict::fail);
    addCount(parts, counts.borderline, Verdict::borderline);
    addCount(parts, counts.pass, Verdict::pass);
    addCount(parts, counts.notApplicable, Verdict::notApplicable);
    addCount(parts, counts.notChecked, Verdict::notChecked);
    return parts.join(QStringLiteral(", "));
}

namespace {

QColor verdictInk(Verdict verdict) {
    switch (verdict) {
        case Verdict::pass:
            return {0x00, 0x5f, 0x9e};
        case Verdict::borderline:
            return {0x7a, 0x5c, 0x00};
        case Verdict::fail:
            return {0xb0, 0x3a, 0x00};
        case Verdict::notApplicable:
        case Verdict::notChecked:
            break;
    }
    return {0x5c, 0x61, 0x6b};
}

}  // namespace

QColor verdictColour(Verdict verdict) {
    const QColor ink = verdictInk(verdict);
    if (themeInUse() == Theme::light) return ink;
    return QColor::fromHsl(ink.hslHue(), ink.hslSaturation(), 255 - ink.lightness());
}

QString describeVerdicts(const ReviewStudy& study) {
    // By verdict from fail to not checked; figures only stand beside what is not applicable.
    std::map<std::pair<int, QString>, std::size_t> counts;
    for (const PlaceReview& place : study.places) {
        const auto order = std::ranges::find(shownOrder, place.verdict) - shownOrder.begin();
        ++counts[{int(order), describeVerdict(place)}];
    }
    QStringList parts;
    for (const auto& [verdict, count] : counts)
        parts << QStringLiteral("%1 %2").arg(formatCount(count), verdict.second);
    return parts.join(QStringLiteral(", "));
}

QString describeStatus(const Rule& rule) {
    const FigureStatus status = findLeastCertain(rule);
    const auto words = [](std::string_view text) {
        return QString::fromUtf8(text.data(), qsizetype(text.size()));
    };
    QStringList names;
    for (const Sentence& name : listLeastCertain(rule)) names << sentenceText(name);
    names.removeDuplicates();
    return QObject::tr("Least sure: %1 (%2, %3)")
        .arg(names.join(QStringLiteral(", ")), words(ruleNameOf(figureStatusNames(), status)),
             translated(meaningOf(status)));
}

namespace {

constexpr int reviewRole = Qt::UserRole, dayRole = Qt::UserRole + 1;
constexpr int verdictColumn = 1, firstRuleColumn = 2;
constexpr std::size_t maxExpanded = 8;  // places whose days are shown at first

QString textOf(const std::string& text) { return QString::fromStdString(text); }

/// The day that says most of a place: the one that decides its verdict, or else the one with most incremental
/// shadow, or the first.
const ReviewRow* mainRow(const PlaceReview& review) {
    for (const CriterionResult& result : review.results)
        for (const ReviewRow& row : review.rows)
            if (result.verdict == review.verdict && result.verdict != Verdict::pass && row.day == result.day)
                return &row;
    const auto found = std::ranges::max_element(review.rows, {}, &ReviewRow::incrementalM2h);
    return found == review.rows.end() ? nullptr : &*found;
}

/// The rows to list: all of fixed days; of a range those with most incremental shadow, in time order.
std::vector<const ReviewRow*> rowsToList(const PlaceReview& review, bool fewDays) {
    std::vector<const ReviewRow*> rows;
    for (const ReviewRow& row : review.rows)
        if (fewDays || row.incrementalM2h > 0) rows.push_back(&row);
    if (fewDays || rows.size() <= VerdictTable::maxDays) return rows;
    std::ranges::stable_sort(rows, std::greater(), &ReviewRow::incrementalM2h);
    rows.resize(VerdictTable::maxDays);
    std::ranges::sort(rows, {}, &ReviewRow::day);
    return rows;
}

// What fails comes first, and of these what gets most incremental shadow.
std::vector<std::size_t> orderByVerdict(const ReviewStudy& study) {
    constexpr std::array rank{2, 1, 0, 3, 4};  // of Verdict's values
    std::vector<std::size_t> order(study.places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t i) {
        const PlaceReview& place = study.places[i];
        return std::pair(rank[std::size_t(place.verdict)], -place.totals.incrementalM2h);
    });
    return order;
}

QString wrapped(QString title) {
    const auto middle = title.indexOf(u' ', title.size() / 2 - 1);
    if (title.size() > 14 && middle > 0) title[middle] = u'\n';
    return title;
}

}  // namespace

VerdictTable::VerdictTable(QWidget* parent) : QTreeWidget(parent) {
    setObjectName(QStringLiteral("verdicts"));
    setUniformRowHeights(true);
    setAllColumnsShowFocus(true);
    setExpandsOnDoubleClick(false);  // a double click zooms to the place
    setHeaderHidden(true);
    header()->setSectionResizeMode(QHeaderView::Interactive);
    connect(this, &QTreeWidget::currentItemChanged, this,
            [this](const QTreeWidgetItem* item) { choose(item); });
    connect(this, &QTreeWidget::itemActivated, this, [this](const QTreeWidgetItem* item) {
        Q_EMIT zoomRequested(item->data(0, reviewRole).toULongLong());
    });
}

void VerdictTable::show(const std::shared_ptr<const ReviewAnswer>& answer, UnitSystem units) {
    const QSignalBlocker block(this);
    const QTreeWidgetItem* before = currentItem();
    const QString name = before ? (before->parent() ? before->parent() : before)->text(0) : QString();
    const QVariant day = before ? before->data(0, dayRole) : QVariant();
    std::map<QString, bool> open;
    const bool sameRule = answer && answer_ && answer->question.rule.key == answer_->question.rule.key;
    const bool alike = sameRule && answer->study.places.size() == answer_->study.places.size();
    for (int i = 0; alike && i < topLevelItemCount(); ++i)
        open[topLevelItem(i)->text(0)] = topLevelItem(i)->isExpanded();
    answer_ = answer;
    clear();
    setHeaderHidden(!answer);
    if (!answer) return setColumnCount(1);
    units_ = units;
    columns_ = columnsIn(units, answer->question.rule.deliverables.columns);
    std::erase_if(columns_,
                  [](const RuleColumn& column) { return column.key == "place" || column.key == "day"; });
    const bool sameColumns = sameRule && columnCount() == int(columns_.size()) + firstRuleColumn;
    QStringList titles{tr("Place and day"), tr("Verdict")};
    for (const RuleColumn& column : columns_) titles << wrapped(ruleName(column.title));
    setColumnCount(int(titles.size()));
    setHeaderLabels(titles);
    for (const std::size_t i : orderByVerdict(answer->study)) addPlace(i);
    for (int i = 0; i < topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = topLevelItem(i);
        const auto was = open.find(item->text(0));
        item->setExpanded(was == open.end() ? std::size_t(topLevelItemCount()) <= maxExpanded : was->second);
        if (item->text(0) != name) continue;
        setCurrentItem(item);
        for (int child = 0; child < item->childCount(); ++child)
            if (day.isValid() && item->child(child)->data(0, dayRole) == day)
                setCurrentItem(item->child(child));
    }
    if (sameColumns) return;
    for (int i = 0; i < columnCount(); ++i) resizeColumnToContents(i);
    setColumnWidth(0, std::min(columnWidth(0), 220));
}

void VerdictTable::addPlace(std::size_t review) {
    const PlaceReview& place = answer_->study.places[review];
    auto* item = new QTreeWidgetItem(this);
    item->setText(0, placeName(place.name));
    item->setText(verdictColumn, describeVerdict(place));
    item->setForeground(verdictColumn, verdictColour(place.verdict));
    QFont bold = font();
    bold.setBold(true);
    item->setFont(verdictColumn, bold);
    for (int i = 0; i < columnCount(); ++i)
        item->setToolTip(i, inWindowWords([&] { return describeReason(place, units_, writeDay); }));
    item->setData(0, reviewRole, qulonglong(review));
    if (place.rows.size() == 1) {  // one day stands in the place's own row
        for (std::size_t i = 0; i < columns_.size(); ++i)
            item->setText(int(i) + firstRuleColumn,
                          localiseNumbers(textOf(columnText(place, place.rows.front(), columns_[i].key))));
        return;
    }
    for (const ReviewRow* row : rowsToList(place, hasFewDays(answer_->question.rule)))
        addDay(*item, review, *row);
}

void VerdictTable::addDay(QTreeWidgetItem& place, std::size_t review, const ReviewRow& row) {
    auto* item = new QTreeWidgetItem(&place);
    item->setText(0, textOf(writeDay(row.day)));
    item->setData(0, reviewRole, qulonglong(review));
    item->setData(0, dayRole, textOf(formatText(row.day)));
    for (std::size_t i = 0; i < columns_.size(); ++i)
        item->setText(
            int(i) + firstRuleColumn,
            localiseNumbers(textOf(columnText(answer_->study.places[review], row, columns_[i].key))));
}

void VerdictTable::choose(const QTreeWidgetItem* item) {
    if (item == nullptr || !answer_) return;
    const std::size_t review = item->data(0, reviewRole).toULongLong();
    const PlaceReview& place = answer_->study.places[review];
    const QString day = item->data(0, dayRole).toString();
    for (const ReviewRow& row : place.rows)
        if (textOf(formatText(row.day)) == day) return Q_EMIT chosen(review, row.day);
    if (const ReviewRow* row = mainRow(place)) Q_EMIT chosen(review, row->day);
}

void VerdictTable::chooseCurrent() {
    if (!currentItem() && topLevelItemCount() > 0) {
        const QSignalBlocker block(this);
        setCurrentItem(topLevelItem(0));
    }
    choose(currentItem());
}

QString VerdictTable::text() const {
    if (!answer_) return {};
    QStringList titles{tr("Place"), tr("Kind"), tr("Verdict"), tr("Day")};
    for (const RuleColumn& column : columns_) titles << textOf(column.title);
    QStringList lines{titles.join(u'\t')};
    for (const PlaceReview& place : answer_->study.places)
        for (const ReviewRow& row : place.rows) {
            QStringList fields{placeName(place.name), describeKind(place.kind),
                               textOf(std::string(nameVerdict(place))), textOf(formatText(row.day))};
            for (const RuleColumn& column : columns_) fields << textOf(columnText(place, row, column.key));
            lines << fields.join(u'\t');
        }
    return lines.join(u'\n') + u'\n';
}

}  // namespace noonmark
