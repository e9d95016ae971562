#pragma once

// The folder app/gui/docks/search finds things of the open project and commands of the menus by name:
// CitySearch is the index and its query, SearchField the field in the menu bar.

#include <QAction>
#include <QLineEdit>
#include <QPointer>
#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "core/city/city.h"
#include "core/receivers/place.h"
#include "scenarios/project/project.h"

class QCompleter;
class QMenu;
class QStandardItemModel;

namespace noonmark {

enum class FoundKind { building, place, street, lot, coordinates, command };

/// One thing that was found.
struct Found {
    FoundKind kind = FoundKind::building;
    QString title;                          ///< "Empire State Building", "5th Avenue"
    QString about;                          ///< "building, way 34633854", "park"
    Box2 box;                               ///< where it is, local metres
    std::optional<std::uint32_t> building;  ///< its index in the city
    std::string name = {};                  ///< of a place, as the project has it
    QPointer<QAction> command = nullptr;    ///< of FoundKind::command; null: its menu has dropped it since
};

/// What can be found by name or id in a city with its places and lots. Immutable once its commands are
/// added.
class CitySearch {
public:
    CitySearch() = default;
    /// O(buildings + streets): 20 ms for 43,000 buildings.
    CitySearch(const City& city, const std::vector<Place>& places, const std::vector<NamedLot>& lots);

    /// The commands of a menu and of those below it; the text of their tooltips is searched, too.
    void addCommands(const QMenu& menu);

    /// At most `maximum`, the best first: equal names, then names that begin with the text, names in which a
    /// word begins with it, and those that contain it; shorter names first. Upper and lower case and accents
    /// make no difference. A text of two numbers is a position: latitude and longitude in either order,
    /// whichever is nearer to the city. Nothing for an empty text. O(entries).
    [[nodiscard]] std::vector<Found> find(const QString& text, std::size_t maximum = 20) const;

private:
    struct Entry {
        Found found;
        QString folded;    ///< of the title
        QString foldedId;  ///< of a building; the tooltip of a command
    };
    void add(Found found, const QString& id = {});

    void addCommands(const QMenu& menu, const QString& path);
    static int rankOf(const Entry& entry, const QString& wanted);

    std::optional<Frame> frame_;  ///< none: no city, and no positions
    std::vector<Entry> entries_;
};

/// Latitude and longitude of "40.7536, -73.9832", "-73.9832 40.7536" or "40.7536N 73.9832W"; of the two
/// readings of plain numbers the one nearer to `near`. Nothing for other texts.
std::optional<LonLat> parsePosition(const QString& text, LonLat near);

/// The field in which a building, a place, a street, a lot, a position or a command is looked for. While the
/// user types, a list shows what fits; Enter takes the first.
class SearchField final : public QLineEdit {
    Q_OBJECT
public:
    explicit SearchField(QWidget* parent = nullptr);

    using MakeIndex = std::function<CitySearch()>;
    /// What is searched from now on; called when the user types next.
    void setIndex(MakeIndex make);
    /// Puts the cursor into the field and selects its text.
    void begin();
    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    void found(const noonmark::Found& found);
    void nothingFound(QString text);

private:
    void search(const QString& text);
    void take(std::size_t place);
    void takeFirst();

    MakeIndex makeIndex_;  ///< empty once it was called
    CitySearch index_;
    std::vector<Found> shown_;
    QStandardItemModel* model_;
    QCompleter* completer_;
};

}  // namespace noonmark
