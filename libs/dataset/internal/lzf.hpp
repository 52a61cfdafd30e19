// LZF (Lehmann's liblzf), the compression of PCD files: literal runs and references to what was written before.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace amiss::dataset {

/// The `size` bytes that `packed` stands for; InputError "NAME: ..." where it does not stand for exactly as many.
[[nodiscard]] std::string lzf_expanded(std::string_view packed, std::size_t size, const std::string& name);

}  // namespace amiss::dataset
