#pragma once

#include "foundation/processes/stop.h"
#include "storage/queries/query.h"

#include <memory>
#include <ostream>

namespace lacuna {

/// Writes rows as an archive of NumPy's arrays, one a column (.npz, as `numpy.savez` writes it), which
/// `numpy.load(allow_pickle=False)` reads; a NULL is NaN or an empty text. Rows are kept, in a temporary file where
/// they are many, and `end` writes them to `stream`, which outlives the object.
std::unique_ptr<QueryOutput> make_numpy_output(std::ostream& stream, const Stop& stop = {});

}  // namespace lacuna
