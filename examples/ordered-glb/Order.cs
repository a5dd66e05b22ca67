// Levels of STRIATA_order (docs/STRIATA_order.md) in C#, from the arrays that any glTF library reads.

public static class Order
{
    /// Returns the indices of the level with n vertices of a primitive.
    public static int[] LevelIndices(int[] indices, uint[] targets, int n)
    {
        var map = new int[targets.Length];
        for (int i = 0; i < map.Length; i++) map[i] = i < n ? i : map[targets[i]];
        var level = new System.Collections.Generic.List<int>(indices.Length);
        for (int i = 0; i < indices.Length; i += 3)
        {
            int a = map[indices[i]], b = map[indices[i + 1]], c = map[indices[i + 2]];
            if (a != b && b != c && c != a) { level.Add(a); level.Add(b); level.Add(c); }
        }
        return level.ToArray();
    }
}
