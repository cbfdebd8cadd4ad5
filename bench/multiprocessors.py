"""What limits the occupancy of NVIDIA GPUs."""
import collections

# Of multiprocessors (CUDA C++ Programming Guide, table "Technical Specifications"): registers and their granularity per
# thread, threads of a warp; by compute capability: warps, bytes of local (shared) memory and what the system takes of it
# for every work-group.
SM_REGISTERS, REGISTER_STEP, WARP = 65536, 8, 32
Multiprocessor = collections.namedtuple("Multiprocessor", "warps shared reserved")
MULTIPROCESSORS = {"sm_75": Multiprocessor(32, 65536, 0), "sm_86": Multiprocessor(48, 102400, 1024)}


def sm_occupancy(sm, registers, local, group):
    warps_of_group = -(-group // WARP)
    rounded = -(-registers // REGISTER_STEP) * REGISTER_STEP
    groups = min(SM_REGISTERS // (rounded * WARP * warps_of_group), sm.warps // warps_of_group)
    if local:
        groups = min(groups, sm.shared // (local + sm.reserved))
    return groups * warps_of_group / sm.warps
