#include "app/gui/docks/search/city_search.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QMenu>
#include <QObject>
#include <QRegularExpression>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "app/gui/session/study/region_text.h"
#include "core/city/map_context.h"
#include "core/geo/lon_lat.h"

namespace noonmark {

namespace {

constexpr float aroundPositionM = 100;

/// Without accents and in lower case: "Café" is found by "cafe".
QString fold(const QString& text) {
    QString plain;
    for (const QChar letter : text.normalized(QString::NormalizationForm_KD))
        if (letter.category() != QChar::Mark_NonSpacing) plain += letter;
    return plain.toCaseFolded().simplified();
}

/// 0: not found; higher is better.
int rank(const QString& name, const QString& wanted) {
    if (name == wanted) return 4;
    if (name.startsWith(wanted)) return 3;
    if (name.contains(u' ' + wanted)) return 2;
    return name.contains(wanted) ? 1 : 0;
}

// Without the mark of its key: "Save &as...".
QString plainTitle(QString title) { return title.remove(u'&'); }

bool isAvailable(const Found& found) {
    return found.kind != FoundKind::command || (found.command && found.command->isEnabled());
}

bool isOnEarth(LonLat place) { return std::abs(place.latDeg) <= 90 && std::abs(place.lonDeg) <= 180; }

Box2 boxOf(const std::vector<Footprint>& polygons) {
    Box2 box;
    for (const Footprint& polygon : polygons) box.add(bounds(polygon));
    return box;
}

/// A street is found once, however many lines have its name.
std::map<std::string, Box2> boxesOfStreets(const MapContext& context) {
    std::map<std::string, Box2> streets;
    for (const ContextLine& line : context.lines) {
        if (line.name.empty() || line.kind == ContextKind::rail) continue;
        for (const glm::vec2 point : line.points) streets[line.name].add(point);
    }
    return streets;
}

}  // namespace

CitySearch::CitySearch(const City& city, const std::vector<Place>& places, const std::vector<NamedLot>& lots)
    : frame_(city.frame) {
    for (std::size_t i = 0; i < city.buildings.size(); ++i) {
        const Building& building = *city.buildings[i];
        const QString id = QString::fromStdString(building.sourceId);
        const QString title = building.name.empty() ? id : QString::fromStdString(building.name);
        add({FoundKind::building, title,
             building.name.empty() ? QObject::tr("building") : QObject::tr("building, %1").arg(id),
             bounds(building), std::uint32_t(i)},
            id);
    }
    for (const Place& place : places)
        add({FoundKind::place,
             placeName(place.name),
             describeKind(place.kind),
             boxOf(place.polygons),
             {},
             place.name});
    for (const NamedLot& lot : lots)
        add({FoundKind::lot, QString::fromStdString(lot.name), QObject::tr("lot"), bounds(lot.outline), {}});
    if (!city.context) return;
    for (const auto& [name, box] : boxesOfStreets(*city.context))
        add({FoundKind::street, QString::fromStdString(name), QObject::tr("street"), box, {}});
}

void CitySearch::add(Found found, const QString& id) {
    QString folded = fold(found.title);
    entries_.push_back({std::move(found), std::move(folded), fold(id)});
}

void CitySearch::addCommands(const QMenu& menu) { addCommands(menu, plainTitle(menu.title())); }

void CitySearch::addCommands(const QMenu& menu, const QString& path) {
    for (QAction* action : menu.actions()) {
        const QString title = plainTitle(action->text());
        if (const QMenu* below = action->menu())
            addCommands(*below, QStringLiteral("%1 > %2").arg(path, title));
        else if (!action->isSeparator())
            add({FoundKind::command, title, path, {}, {}, {}, action}, action->toolTip());
    }
}

// Tooltips say more than a name: what is found there alone comes last.
int CitySearch::rankOf(const Entry& entry, const QString& wanted) {
    const int title = 2 * rank(entry.folded, wanted), other = rank(entry.foldedId, wanted);
    return std::max(title, entry.found.kind == FoundKind::command ? std::min(other, 1) : 2 * other);
}

std::vector<Found> CitySearch::find(const QString& text, std::size_t maximum) const {
    const QString wanted = fold(text);
    if (wanted.isEmpty()) return {};
    std::vector<Found> found;
    if (const auto at = frame_ ? parsePosition(text, frame_->origin()) : std::nullopt) {
        const glm::vec2 point(frame_->localFromLonLat(*at));
        found.push_back({FoundKind::coordinates,
                         text.trimmed(),
                         QObject::tr("position"),
                         {point - aroundPositionM, point + aroundPositionM},
                         {}});
    }
    std::vector<std::pair<int, const Entry*>> ranked;
    for (const Entry& entry : entries_)
        if (const int how = rankOf(entry, wanted); how > 0) ranked.emplace_back(-how, &entry);
    const auto order = [](const auto& one) {
        return std::tuple(one.first, one.second->folded.size(), one.second->folded);
    };
    std::ranges::stable_sort(ranked, {}, order);
    for (const auto& [how, entry] : ranked)
        if (found.size() < maximum && isAvailable(entry->found)) found.push_back(entry->found);
    return found;
}

std::optional<LonLat> parsePosition(const QString& text, LonLat near) {
    static const QRegularExpression two(QStringLiteral(
        R"(^\s*([-+]?\d+(?:\.\d+)?)\s*°?\s*([NSns]?)\s*[,; ]\s*([-+]?\d+(?:\.\d+)?)\s*°?\s*([EWOewo]?)\s*$)"));
    const QRegularExpressionMatch match = two.match(text);
    if (!match.hasMatch()) return std::nullopt;
    double first = match.captured(1).toDouble(), second = match.captured(3).toDouble();
    const QString north = match.captured(2).toUpper(), east = match.captured(4).toUpper();
    if (north == QLatin1String("S")) first = -first;
    if (east == QLatin1String("W")) second = -second;
    const LonLat latFirst{second, first}, lonFirst{first, second};
    if (!north.isEmpty() || !east.isEmpty() || !isOnEarth(lonFirst))
        return isOnEarth(latFirst) ? std::optional(latFirst) : std::nullopt;
    if (!isOnEarth(latFirst)) return lonFirst;
    return computeGreatCircleM(latFirst, near) <= computeGreatCircleM(lonFirst, near) ? latFirst : lonFirst;
}

namespace {

constexpr int titleRole = Qt::UserRole + 1;  // what the field says once an entry is chosen
constexpr int listWidth = 420;               // pixels: names are longer than the field

}  // namespace

SearchField::SearchField(QWidget* parent)
    : QLineEdit(parent), model_(new QStandardItemModel(this)), completer_(new QCompleter(model_, this)) {
    setObjectName(QStringLiteral("search"));
    setPlaceholderText(tr("Find (Ctrl+F)"));
    setToolTip(
        tr("A building by name or id, a street, a place, a lot, a position such as 40.7536, -73.9832, or a "
           "command"));
    setClearButtonEnabled(true);
    setFixedHeight(sizeHint().height());
    completer_->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
    completer_->setCompletionRole(titleRole);
    setCompleter(completer_);
    completer_->popup()->setMinimumWidth(listWidth);
    completer_->popup()->setTextElideMode(Qt::ElideRight);
    completer_->popup()->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(this, &QLineEdit::textEdited, this, &SearchField::search);
    // Not with this field as the receiver: where it loses the focus, QLineEdit ends all connections of its
    // completer with itself.
    connect(completer_, qOverload<const QModelIndex&>(&QCompleter::activated), model_,
            [this](const QModelIndex& index) { take(std::size_t(index.row())); });
    connect(this, &QLineEdit::returnPressed, this, &SearchField::takeFirst);
}

// A menu bar makes no room for more than this, and is no higher than its titles.
QSize SearchField::sizeHint() const {
    constexpr int widthPx = 220, aroundPx = 6;
    return {widthPx, fontMetrics().height() + aroundPx};
}

void SearchField::setIndex(MakeIndex make) {
    makeIndex_ = std::move(make);
    shown_.clear();
    model_->clear();
}

void SearchField::begin() {
    setFocus(Qt::ShortcutFocusReason);
    selectAll();
}

void SearchField::search(const QString& text) {
    if (makeIndex_) index_ = std::exchange(makeIndex_, nullptr)();
    shown_ = index_.find(text);
    model_->clear();
    for (const Found& found : shown_) {
        auto* row = new QStandardItem(QStringLiteral("%1 (%2)").arg(found.title, found.about));
        row->setData(found.title, titleRole);
        model_->appendRow(row);
    }
}

void SearchField::take(std::size_t place) {
    if (place >= shown_.size()) return;
    const Found chosen = shown_[place];  // a change of the project empties the list
    setText(chosen.title);
    Q_EMIT found(chosen);
}

// A choice in the list has been taken already.
void SearchField::takeFirst() {
    if (completer_->popup()->currentIndex().isValid()) return;
    search(text());
    if (shown_.empty()) return Q_EMIT nothingFound(text());
    completer_->popup()->hide();
    take(0);
}

}  // namespace noonmark
