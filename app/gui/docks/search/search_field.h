#pragma once

#include <QLineEdit>
#include <functional>

#include "app/gui/docks/search/city_search.h"

class QCompleter;
class QStandardItemModel;

namespace noonmark {

/// The field in which a building, a place, a street, a lot or a position is looked for. While the user types,
/// a list shows what fits; Enter takes the first.
class SearchField final : public QLineEdit {
    Q_OBJECT
public:
    explicit SearchField(QWidget* parent = nullptr);

    using MakeIndex = std::function<CitySearch()>;
    /// What is searched from now on; called when the user types next.
    void setIndex(MakeIndex make);
    /// Puts the cursor into the field and selects its text.
    void begin();

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
