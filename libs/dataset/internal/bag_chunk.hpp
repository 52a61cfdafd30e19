// The two compressions of ROS bags' chunks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace amiss::dataset {

/// "none", "bz2" or "lz4": the `size` bytes that `packed` stands for. InputError "NAME: ..." for another compression and
/// where it does not stand for exactly as many. Memory grows with what is unpacked, not with what is promised.
[[nodiscard]] std::string chunk_expanded(std::string_view packed, std::string_view compression, std::size_t size,
                                         const std::string& name);

}  // namespace amiss::dataset
