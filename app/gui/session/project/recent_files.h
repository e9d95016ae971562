#pragma once

#include <QImage>
#include <QStringList>

#include "core/io/read_city.h"

class QSettings;

namespace noonmark {

/// Recently opened files or samples, newest first. An entry is a path, or several joined by newlines if they
/// were opened together, with the reading settings used last.
class RecentFiles {
public:
    static constexpr int maximum = 10;
    explicit RecentFiles(QSettings& settings);

    [[nodiscard]] QStringList entries() const;
    void add(const QStringList& files, const ReadSettings& reading = {});
    void clear();

    /// The reading settings of an entry. Empty text: defaults, or an entry written by an older version.
    [[nodiscard]] ReadSettings readingOf(const QString& entry) const;
    [[nodiscard]] QString readingTextOf(const QString& entry) const;

    /// A small picture of the view of an entry, no wider than pictureSize; null: none was taken.
    [[nodiscard]] QImage pictureOf(const QString& entry) const;
    /// Keeps it with the entry, scaled down; nothing if the entry is no longer in the list.
    void setPicture(const QString& entry, const QImage& picture);
    static constexpr QSize pictureSize{192, 128};

    static bool exists(const QString& entry);  ///< all its files exist; samples always do
    static bool isSampleEntry(const QString& entry);
    static QStringList filesOf(const QString& entry);
    static QString nameOf(const QString& entry);  ///< menu text: the file's name, "and 2 more"

private:
    void keepPictures(const QStringList& entries);
    void keepReading(const QStringList& entries, const QString& newest, const ReadSettings& reading);

    QSettings& settings_;
};

}  // namespace noonmark
